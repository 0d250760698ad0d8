package org.sami.boat.app.screen;

import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;

/** An address for pictures, in place of that of the machine that draws them. */
@Implements(PhoneAddress.class)
public class PictureAddress {
    /** As on a phone's own Wi-Fi. */
    @Implementation
    protected static String now() {
        return "192.168.43.7";
    }
}
