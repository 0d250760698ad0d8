package org.sami.dreamm.canvas;

import java.util.Set;
import org.sami.spn.edit.Edit;

/**
 * An edit with what it makes.
 *
 * @param made ids of new vertices and edges, notes and frames, to be selected
 */
record MakingEdit(Edit edit, Set<String> made) {}
