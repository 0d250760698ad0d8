/**
 * Ways from one place to another: straight, shortest around what is forbidden, safest with a clearance (appendix .2.1, Path Request).
 *
 * <p>Belongs here: algorithms that find one way. Does not belong here: how a boat follows it ({@code crw.proxy}), orders of
 * several places ({@code crw.service.allocation}).
 */
@NullMarked
package org.sami.crw.service.path;

import org.jspecify.annotations.NullMarked;
