// The sums over the pool's bits, a binary tree: from a rank down to a free slot, and from the words up to the root. Node i has the
// children 2 i and 2 i + 1; node i of the sums stands at words + i, and the words are the nodes from `words` on.
#import bisectors

// Live slots under a node of the tree, whose leaves are the words.
fn live_under(node: u32) -> u32 {
    let words = capacity() >> 5u;
    if node < words { return atomicLoad(&tree[words + node]); }
    return countOneBits(atomicLoad(&tree[node - words]));
}

// The free slot of a rank: down the sums, then within the word.
fn free_slot(rank: u32) -> u32 {
    let words = capacity() >> 5u;
    var left = rank;
    var node = 1u;
    var bits = capacity();
    while node < words {
        node *= 2u;
        bits >>= 1u;
        let free = bits - live_under(node);
        if left >= free {
            left -= free;
            node += 1u;
        }
    }
    var word = ~atomicLoad(&tree[node - words]);
    for (; left > 0u; left--) { word &= word - 1u; }
    return 32u * (node - words) + firstTrailingBit(word);
}

var<workgroup> sums: array<u32, 256>;

// Halves the 256 sums in the workgroup's memory again and again; level by level they become the nodes above `first`.
fn sum_up(lane: u32, first: u32, count: u32) {
    let words = capacity() >> 5u;
    var node = first;
    for (var n = count / 2u; n > 0u; n /= 2u) {
        workgroupBarrier();
        var pair = 0u;
        if lane < n { pair = sums[2u * lane] + sums[2u * lane + 1u]; }
        workgroupBarrier();
        node /= 2u;
        if lane < n {
            sums[lane] = pair;
            atomicStore(&tree[words + node + lane], pair);
        }
    }
}
