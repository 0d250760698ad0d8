/**
 * What the operator reads and answers: messages, and decisions that wait for an answer. Immutable values, and the interfaces by which
 * they are handed on.
 *
 * <p>Does not belong here: in which order they lie before the operator ({@code org.sami.crw.operator}), how a decision is presented and
 * answered ({@code org.sami.crw.decision}).
 */
@NullMarked
package org.sami.crw.message;

import org.jspecify.annotations.NullMarked;
