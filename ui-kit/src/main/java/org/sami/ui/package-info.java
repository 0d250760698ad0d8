/** What the operator's window and the plan editor share. It knows plans and values, and no boat. */
package org.sami.ui;
