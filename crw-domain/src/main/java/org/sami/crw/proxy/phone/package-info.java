/**
 * What a base offers to a phone nearby while a person shows the code for it: the app, and the pairing that the phone asks for.
 *
 * <p>Not here: the pairing that a base asks a boat for ({@code org.sami.crw.proxy.tcp}), pictures of the code, questions to a person.
 */
@NullMarked
package org.sami.crw.proxy.phone;

import org.jspecify.annotations.NullMarked;
