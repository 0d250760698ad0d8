package org.sami.spn.suggestion;

import org.sami.spn.edit.Edit;

/**
 * Requirements to be tried on an edge.
 *
 * @param words in the words of the language
 * @param edit writes them on the edge
 * @param changes how many requirements come or go, compared with those that stand there
 */
record Candidate(String words, Edit edit, int changes) {}
