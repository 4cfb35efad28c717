//! Shaders that count what they read: every sample of a texture, texel load and load from a buffer, as it happens, loops and branches
//! included.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{
    AddressSpace, Arena, BinaryOperator, Block, Expression, Function, GlobalVariable, Handle, ImageClass, Literal,
    Module, Range, Span, Statement, Type, TypeInner, VectorSize,
};

/// What marks a pixel whose fragment has counted: its fourth channel.
pub const MARK: f32 = 4096.0;

/// What was read: samples of textures, loads of texels, loads from storage buffers, and the bytes of all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reads {
    /// Through a sampler.
    pub samples: f64,
    /// Without one.
    pub texels: f64,
    /// From storage buffers, scalars, vectors or structs.
    pub loads: f64,
    /// Texels that a sampler touches and those loaded, and what was loaded from storage buffers. Uniform blocks do not count.
    pub bytes: f64,
}

impl Reads {
    /// From what a fragment of [`counting`] returns: the counts of samples and of texel loads share a channel.
    pub fn from_pixel(pixel: [f32; 4]) -> Self {
        let ([first, loads, bytes, _], mark) = (pixel.map(f64::from), f64::from(MARK));
        Self { samples: (first / mark).floor(), texels: first.rem_euclid(mark), loads, bytes }
    }

    fn to_vector(self) -> [f32; 3] {
        [self.samples * f64::from(MARK) + self.texels, self.loads, self.bytes].map(|number| number as f32)
    }
}

impl std::ops::AddAssign for Reads {
    fn add_assign(&mut self, other: Self) {
        self.samples += other.samples;
        self.texels += other.texels;
        self.loads += other.loads;
        self.bytes += other.bytes;
    }
}

/// The shader with an entry point named `fragment` that returns its [`Reads`] instead of a colour. `bytes` tells of a texture, by its
/// name in the shader, how many bytes a sample touches and how many a texel has.
///
/// # Panics
/// When naga refuses the shader.
pub fn counting(source: &str, bytes: &dyn Fn(&str) -> [f64; 2]) -> String {
    let mut module = naga::front::wgsl::parse_str(source).unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    let vector = |size| Type { name: None, inner: TypeInner::Vector { size, scalar: naga::Scalar::F32 } };
    let three = module.types.insert(vector(VectorSize::Tri), Span::UNDEFINED);
    let four = module.types.insert(vector(VectorSize::Quad), Span::UNDEFINED);
    let counter = module.global_variables.append(
        GlobalVariable {
            name: Some("reads".into()),
            space: AddressSpace::Private,
            binding: None,
            ty: three,
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        },
        Span::UNDEFINED,
    );
    let counting = Counting { three, four, counter, bytes };
    // Functions and the module they are read against cannot be lent at once.
    let read_only = module.clone();
    for (_, function) in module.functions.iter_mut() {
        counting.rewrite(&read_only, function, false);
    }
    for entry in module.entry_points.iter_mut().filter(|entry| entry.name == "fragment") {
        counting.rewrite(&read_only, &mut entry.function, true);
    }
    let info = Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    naga::back::wgsl::write_string(&module, &info, naga::back::wgsl::WriterFlags::empty()).expect("writable WGSL")
}

struct Counting<'a> {
    three: Handle<Type>,
    four: Handle<Type>,
    counter: Handle<GlobalVariable>,
    bytes: &'a dyn Fn(&str) -> [f64; 2],
}

impl Counting<'_> {
    fn rewrite(&self, module: &Module, function: &mut Function, is_entry: bool) {
        let body = std::mem::take(&mut function.body);
        function.body = self.block(module, function, &body, is_entry);
    }

    fn block(&self, module: &Module, function: &mut Function, block: &Block, is_entry: bool) -> Block {
        let mut counted = Block::new();
        for statement in block.iter().cloned() {
            let mut of = |block: Block| self.block(module, function, &block, is_entry);
            let statement = match statement {
                Statement::Emit(range) => {
                    let read = self.reads(module, function, range.clone());
                    counted.push(Statement::Emit(range), Span::UNDEFINED);
                    if read != Reads::default() {
                        self.count(function, read, &mut counted);
                    }
                    continue;
                }
                Statement::Block(block) => Statement::Block(of(block)),
                Statement::If { condition, accept, reject } => {
                    Statement::If { condition, accept: of(accept), reject: of(reject) }
                }
                Statement::Switch { selector, cases } => {
                    let cases =
                        cases.into_iter().map(|case| naga::SwitchCase { body: of(case.body), ..case }).collect();
                    Statement::Switch { selector, cases }
                }
                Statement::Loop { body, continuing, break_if } => {
                    Statement::Loop { body: of(body), continuing: of(continuing), break_if }
                }
                Statement::Return { value: Some(_) } if is_entry => self.report(function, &mut counted),
                other => other,
            };
            counted.push(statement, Span::UNDEFINED);
        }
        counted
    }

    /// What the expressions of a range read when they are evaluated.
    fn reads(&self, module: &Module, function: &Function, range: Range<Expression>) -> Reads {
        let expressions = &function.expressions;
        let mut sum = Reads::default();
        for handle in range {
            match &expressions[handle] {
                Expression::ImageSample { image, .. } => {
                    sum += Reads {
                        samples: 1.0,
                        bytes: self.texture_bytes(module, expressions, *image)[0],
                        ..Reads::default()
                    };
                }
                Expression::ImageLoad { image, .. } => {
                    sum += Reads {
                        texels: 1.0,
                        bytes: self.texture_bytes(module, expressions, *image)[1],
                        ..Reads::default()
                    };
                }
                Expression::Load { pointer } => {
                    if let Some(bytes) = storage_bytes(module, function, *pointer) {
                        sum += Reads { loads: 1.0, bytes, ..Reads::default() };
                    }
                }
                _ => {}
            }
        }
        sum
    }

    fn texture_bytes(&self, module: &Module, expressions: &Arena<Expression>, image: Handle<Expression>) -> [f64; 2] {
        let Expression::GlobalVariable(texture) = expressions[image] else {
            panic!("a texture that is no global variable")
        };
        let variable = &module.global_variables[texture];
        if let TypeInner::Image { class: ImageClass::Depth { .. }, .. } = module.types[variable.ty].inner {
            return [4.0, 4.0];
        }
        (self.bytes)(variable.name.as_deref().expect("textures have names"))
    }

    /// `reads += …`
    fn count(&self, function: &mut Function, read: Reads, block: &mut Block) {
        let expressions = &mut function.expressions;
        let mut add = |expression| expressions.append(expression, Span::UNDEFINED);
        let numbers = read.to_vector().map(|number| add(Expression::Literal(Literal::F32(number))));
        let pointer = add(Expression::GlobalVariable(self.counter));
        let more = add(Expression::Compose { ty: self.three, components: numbers.to_vec() });
        let now = add(Expression::Load { pointer });
        let sum = add(Expression::Binary { op: BinaryOperator::Add, left: now, right: more });
        block.push(Statement::Emit(Range::new_from_bounds(more, sum)), Span::UNDEFINED);
        block.push(Statement::Store { pointer, value: sum }, Span::UNDEFINED);
    }

    /// `return vec4f(reads, MARK)`
    fn report(&self, function: &mut Function, block: &mut Block) -> Statement {
        let expressions = &mut function.expressions;
        let mut add = |expression| expressions.append(expression, Span::UNDEFINED);
        let mark = add(Expression::Literal(Literal::F32(MARK)));
        let pointer = add(Expression::GlobalVariable(self.counter));
        let reads = add(Expression::Load { pointer });
        let all = add(Expression::Compose { ty: self.four, components: vec![reads, mark] });
        block.push(Statement::Emit(Range::new_from_bounds(reads, all)), Span::UNDEFINED);
        Statement::Return { value: Some(all) }
    }
}

/// Bytes behind a pointer into a storage buffer; `None` behind any other.
fn storage_bytes(module: &Module, function: &Function, pointer: Handle<Expression>) -> Option<f64> {
    let mut path = Vec::new();
    let mut at = pointer;
    let variable = loop {
        match function.expressions[at] {
            Expression::Access { base, .. } => (path.push(0), at = base).1,
            Expression::AccessIndex { base, index } => (path.push(index as usize), at = base).1,
            Expression::GlobalVariable(variable) => break &module.global_variables[variable],
            _ => return None,
        }
    };
    let AddressSpace::Storage { .. } = variable.space else { return None };
    let mut inner = &module.types[variable.ty].inner;
    for step in path.into_iter().rev() {
        inner = match inner {
            TypeInner::Array { base, .. } => &module.types[*base].inner,
            TypeInner::Struct { members, .. } => &module.types[members[step].ty].inner,
            TypeInner::Vector { scalar, .. } => return Some(f64::from(scalar.width)),
            other => panic!("a pointer into {other:?}"),
        };
    }
    Some(f64::from(inner.size(module.to_ctx())))
}
