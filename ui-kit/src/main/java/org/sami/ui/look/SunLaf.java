package org.sami.ui.look;

import com.formdev.flatlaf.FlatLightLaf;

/** Black on white with heavy lines, for a screen in the sun. Its changes are in the properties file of the same name. */
public final class SunLaf extends FlatLightLaf {
    @Override
    public String getName() {
        return "SAMI Sun";
    }
}
