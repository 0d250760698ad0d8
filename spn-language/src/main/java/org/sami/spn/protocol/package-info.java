/**
 * What goes into the engine and what comes out of it: inputs, occurrences, effects, activations, decisions, tokens.
 *
 * <p>Belongs here: immutable messages between engine, journal, hosts and handlers; every engine of this language speaks
 * them. Does not belong here: how markings change ({@code spn.engine}), how messages are stored ({@code spn.journal}).
 *
 * <p>Ids of missions, activations, visits, decisions and firings are whole numbers from 1 upwards, given by the engine in
 * order of creation; 0 ({@link org.sami.spn.protocol.Ids#NONE}) says "none". Times are milliseconds on the session's
 * clock, which the host injects.
 */
@NullMarked
package org.sami.spn.protocol;

import org.jspecify.annotations.NullMarked;
