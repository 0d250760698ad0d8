package org.sami.ui.look;

import com.formdev.flatlaf.FlatDarkLaf;

/** Dark grey surfaces, one blue accent. What it changes stands in the file of its name beside it. */
public final class DarkLaf extends FlatDarkLaf {
    @Override
    public String getName() {
        return "SAMI Dark";
    }
}
