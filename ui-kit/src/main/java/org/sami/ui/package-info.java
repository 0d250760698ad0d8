/** What the operator's window and the plan editor share. It knows plans and values, and no boat. */
@NullMarked
package org.sami.ui;

import org.jspecify.annotations.NullMarked;
