# The program and its page. `make run` and `make test` need nothing installed but Rust (rustup) and Node with npm.

.PHONY: run build test soak bench bake gallery fmt lint

run:    ## sets up, builds and serves the page on http://127.0.0.1:8080 (PORT=9000 make run: on another port)
	@scripts/run.sh

build:  ## builds the page for visitors, as small as it goes, into dist/, and the native program, if anything has changed
	@scripts/build.sh

test:   ## sets up and runs every test: native, headless GPU, Firefox and Chromium
	@scripts/test.sh

soak:   ## checks that take too long for every day
	@cargo test --release --locked --test pictures -- --ignored

bench:  ## measures the waves on CPU and GPU, what a pixel of the sea reads, then what a frame costs at every named view and from five heights; tables, and JSON in target/bench
	@cargo bench --locked --bench waves
	@cargo bench --locked --bench accesses
	@cargo run --release --locked -- bench -o target/bench/views.json

bake:   ## makes the bundled world anew from its public sources
	@scripts/make-world.sh

gallery: ## draws docs/gallery from its links, and the small pictures of the named views
	@scripts/make-gallery.sh

fmt:    ## formats the code
	@cargo fmt

lint:   ## what a reviewer would say first
	@scripts/lint.sh
