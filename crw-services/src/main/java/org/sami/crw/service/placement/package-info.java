/**
 * Places for boats near a point (appendix .2.1, Assemble Location Request), and locations spread over an area.
 *
 * <p>Belongs here: algorithms that find places clear of each other and of what is forbidden. Does not belong here: who remembers which place was given
 * ({@code crw.handler}), ways there ({@code crw.service.path}).
 */
@NullMarked
package org.sami.crw.service.placement;

import org.jspecify.annotations.NullMarked;
