/**
 * Components with which values are shown and given: what Algorithms 4 to 6 choose (thesis 5.2.4), built. One editor a component of the
 * domain's {@code components.json}; forms, lists and tables around them; questions of the engine.
 *
 * <p>Belongs here: editors of values, how values are typed and written. Does not belong here: which component is chosen
 * ({@code spn.component}), what a decision means, a window that shows one. All classes but the {@code Text} ones live on the event thread.
 */
@NullMarked
package org.sami.ui.value;

import org.jspecify.annotations.NullMarked;
