/**
 * Where SQLite's native library comes from, for everybody who opens a database. Does not belong here: what is in a database (journals are in
 * {@code org.sami.spn.journal}).
 */
@NullMarked
package org.sami.spn.sqlite;

import org.jspecify.annotations.NullMarked;
