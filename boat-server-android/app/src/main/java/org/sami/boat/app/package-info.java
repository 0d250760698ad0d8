/**
 * The app on the phone of a hull (docs/boat-app.md): its service and what begins it.
 *
 * <p>Not here: the boat server, the control board, the position filter, which know nothing of Android. Java 8 level, Android API 26.
 */
package org.sami.boat.app;
