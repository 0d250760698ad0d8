/**
 * Allocation of work to boats: which boat does what, and in which order (thesis 7.0.3, appendix .2.1 Allocation Request).
 *
 * <p>Here: algorithms, one class each, and what they share. Not here: events, tasks of missions, boat proxies.
 *
 * <p>Work that needs capabilities goes only to boats that offer them; work without such a boat is unallocated, with the missing capabilities. Lengths
 * are of straight legs, on a plane for comparing and along the surface for reports; where areas have to be avoided, they are of the ways around them.
 */
@NullMarked
package org.sami.crw.service.allocation;

import org.jspecify.annotations.NullMarked;
