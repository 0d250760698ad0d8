/**
 * Changes to plans and projects as objects: edits with what they take along, where a name is used, and a history to undo and redo.
 *
 * <p>Belongs here: edits of immutable plans, the builder of plans, what keeps a project well-formed. Does not belong here: windows,
 * files, and checks of what a plan means ({@code spn.analysis}).
 *
 * <p>Reading order: {@link org.sami.spn.edit.Edit}, {@link org.sami.spn.edit.EditResult}, {@link org.sami.spn.edit.EditHistory}, then the
 * edits themselves.
 */
@NullMarked
package org.sami.spn.edit;

import org.jspecify.annotations.NullMarked;
