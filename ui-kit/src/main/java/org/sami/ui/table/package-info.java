/** Tables of immutable rows that models replace: selection stays with what a row is about, and an empty table says what would appear in it. */
@NullMarked
package org.sami.ui.table;

import org.jspecify.annotations.NullMarked;
