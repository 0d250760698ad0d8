/**
 * Coverage of areas: tracks on which boats come near every point of an area (thesis 6.2, Explore Area; appendix .2.1, Proxy Explore
 * Area).
 *
 * <p>Belongs here: lanes, their order, the division of a track among boats, what stays uncovered. Does not belong here: the boats'
 * commands ({@code crw.handler}), ways around what is forbidden ({@code crw.service.path}).
 *
 * <p>All geometry is on a plane that touches at the area; lengths and areas that are reported are measured on it too.
 */
@NullMarked
package org.sami.crw.service.coverage;

import org.jspecify.annotations.NullMarked;
