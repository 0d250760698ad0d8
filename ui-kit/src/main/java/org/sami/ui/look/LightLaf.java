package org.sami.ui.look;

import com.formdev.flatlaf.FlatLightLaf;

/** Light grey surfaces, one blue accent. What it changes stands in the file of its name beside it. */
public final class LightLaf extends FlatLightLaf {
    @Override
    public String getName() {
        return "SAMI Light";
    }
}
