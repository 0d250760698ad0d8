/**
 * Whether a boat should be sent where a plan sends it: how far that is, whether its charge lasts, whether land lies there
 * (docs/services.md).
 *
 * <p>Here belongs what is said of a way; pure functions of positions and charges. Who is asked and what becomes of the boats
 * belongs to {@code crw.handler}.
 */
@NullMarked
package org.sami.crw.service.reach;

import org.jspecify.annotations.NullMarked;
