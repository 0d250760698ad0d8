/**
 * Where boats may go, as the project and the missions say: the fence, the no-go areas and the areas that plans avoid.
 *
 * <p>Belongs here: which areas those are now, and whether a path keeps to them. Does not belong here: the alarm when one does not ({@code
 * org.sami.crw.operator.alarm}), ways around areas ({@code org.sami.crw.service.path}).
 */
@NullMarked
package org.sami.crw.area;

import org.jspecify.annotations.NullMarked;
