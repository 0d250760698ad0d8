package org.sami.ui.map.base;

import java.io.IOException;

/** What is wrong with a document, in one line; who reads the file says where. */
final class GeoJsonFault extends IOException {
    private static final long serialVersionUID = 1;

    GeoJsonFault(String message) {
        super(message);
    }
}
