/**
 * Places for boats: near a point (appendix .2.1, Assemble Location Request), or spread over an area.
 *
 * <p>Belongs here: algorithms that give each boat a place of its own. Does not belong here: who remembers which place was given
 * ({@code crw.handler}), ways there ({@code crw.service.path}).
 */
@NullMarked
package org.sami.crw.service.assembly;

import org.jspecify.annotations.NullMarked;
