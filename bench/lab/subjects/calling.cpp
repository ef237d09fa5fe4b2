// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/calling.hpp"

namespace operations {

Calling calling_of(const reference::Subject& subject) {
    const reference::OperationShape& shape = reference::shape(subject.operation);
    const int result_size = subject.format.width / 8;
    const int operand_size = subject.operand_format.width / 8;
    const std::size_t vectors = reference::vector_operands(subject.operation);
    const bool returns = shape.results == 1;

    Calling calling{{returns ? result_size : 0, {}}, {}};
    if (vectors) {
        calling.signature.operands.assign(vectors, simulator::pointer_size);
        calling.pointers.vectors = vectors;
        calling.pointers.elements = shape.operands / vectors;
        calling.pointers.element_size = operand_size;
    } else {
        calling.signature.operands.assign(shape.operands, operand_size);
        if (reference::is_shift(subject.operation)) calling.signature.operands[1] = 1;
    }
    if (!returns) {
        calling.signature.operands.push_back(simulator::pointer_size);
        calling.pointers.results = shape.results;
        calling.pointers.result_size = result_size;
    }
    return calling;
}

}  // namespace operations
