/**
 * Allocation of work to boats: who does what, and in which order (thesis 7.0.3, appendix .2.1 Allocation Request).
 *
 * <p>Belongs here: algorithms, each in a class, and what they share. Does not belong here: events, tasks of missions, boats'
 * proxies.
 *
 * <p>Work that needs capabilities goes only to boats that offer them; what no boat can do is named as unallocated, with what is
 * missing. Lengths are of straight legs, on a plane while comparing and along the surface where they are reported; or where areas are to be
 * avoided of the ways around them.
 */
package org.sami.crw.service.allocation;
