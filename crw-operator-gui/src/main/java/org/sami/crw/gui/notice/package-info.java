/** News for the operator that needs no answer: messages and alarms. */
@NullMarked
package org.sami.crw.gui.notice;

import org.jspecify.annotations.NullMarked;
