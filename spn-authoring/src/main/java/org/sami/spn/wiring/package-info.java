/**
 * Which data reaches a field of an event, and the edits that read it from there: answers and variables of the field's type that come before
 * the event's place, nearest first, and the entering task ({@code @task}, thesis 9.3.4). Answers about plans; no window, no running.
 */
@NullMarked
package org.sami.spn.wiring;

import org.jspecify.annotations.NullMarked;
