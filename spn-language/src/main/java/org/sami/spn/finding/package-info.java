/**
 * Findings: problems of files and plans as data, collected and never thrown.
 *
 * <p>Belongs here: the finding, its severity and its place in a file. Does not belong here: the checks themselves ({@code spn.json},
 * {@code spn.analysis}).
 */
@NullMarked
package org.sami.spn.finding;

import org.jspecify.annotations.NullMarked;
