package org.sami.ui.look;

import com.formdev.flatlaf.FlatLightLaf;

/** Black on white with heavy lines, for a screen in the sun. What it changes stands in the file of its name beside it. */
public final class SunLaf extends FlatLightLaf {
    @Override
    public String getName() {
        return "SAMI Sun";
    }
}
