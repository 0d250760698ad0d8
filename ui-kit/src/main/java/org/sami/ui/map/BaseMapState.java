package org.sami.ui.map;

import java.nio.file.Path;

/**
 * A base map as people see it in a list.
 *
 * @param name what people call it
 * @param on whether it is to be shown
 * @param problem why it is not shown although it is to be; empty where it is
 */
public record BaseMapState(Path file, String name, boolean on, String problem) {}
