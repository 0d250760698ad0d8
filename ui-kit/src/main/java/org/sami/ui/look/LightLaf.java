package org.sami.ui.look;

import com.formdev.flatlaf.FlatLightLaf;

/** Light grey surfaces, one blue accent. Its changes are in the properties file of the same name. */
public final class LightLaf extends FlatLightLaf {
    @Override
    public String getName() {
        return "SAMI Light";
    }
}
