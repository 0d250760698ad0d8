/**
 * A session's state as rows of JSON, and the rows that changed (docs/session-link.md). Reads snapshots of models only; commands belong to
 * {@code org.sami.session.server}.
 */
@NullMarked
package org.sami.session.rows;

import org.jspecify.annotations.NullMarked;
