/**
 * Files and messages as JSON: vocabularies, projects, values, and what the engine takes in and gives out.
 *
 * <p>Belongs here: readers that report every problem as a finding with its JSON pointer, writers with a stable order, the
 * library of plans that a domain ships. Does not belong here: what a plan means and whether it makes sense
 * ({@code spn.analysis}), where journals store their text ({@code spn.journal}).
 */
@NullMarked
package org.sami.spn.json;

import org.jspecify.annotations.NullMarked;
