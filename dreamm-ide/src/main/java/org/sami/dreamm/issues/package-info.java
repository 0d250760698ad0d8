/**
 * What is wrong with the project as it is written: findings that live with the edits, deep checks on demand, and the view of both (thesis 5.1,
 * Mission Issues View). What is checked stands in {@code org.sami.spn.analysis}.
 */
@NullMarked
package org.sami.dreamm.issues;

import org.jspecify.annotations.NullMarked;
