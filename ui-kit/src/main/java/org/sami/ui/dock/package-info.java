/**
 * Panels of a window that can be moved, stacked, set free and closed, and whose arrangement is remembered: Modern Docking behind three classes
 * of our own. It knows no panel by name.
 */
@NullMarked
package org.sami.ui.dock;

import org.jspecify.annotations.NullMarked;
