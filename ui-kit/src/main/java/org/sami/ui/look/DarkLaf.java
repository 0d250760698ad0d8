package org.sami.ui.look;

import com.formdev.flatlaf.FlatDarkLaf;

/** Dark grey surfaces, one blue accent. Its changes are in the properties file of the same name. */
public final class DarkLaf extends FlatDarkLaf {
    @Override
    public String getName() {
        return "SAMI Dark";
    }
}
