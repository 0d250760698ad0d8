package org.sami.crw.cli.board;

import java.io.IOException;

/** What opens a device. */
interface DeviceOpening {
    /** Opens it. */
    void open() throws IOException;

    /** Opens a port; a failure names the option and says what to do. */
    static void open(String option, DevicePort device, DeviceOpening opening) throws IOException {
        try {
            opening.open();
        } catch (IOException e) {
            String what = device.port().name() + " (" + option + "): " + e.getMessage();
            throw new IOException(what + "; " + advice(device), e);
        }
    }

    private static String advice(DevicePort device) {
        if (device.serial()) {
            return "plug it in and name its port (" + SerialStreamPort.present() + ")";
        }
        return device.gpsd() ? "start gpsd, or name where it runs" : "start what listens there, or name another port";
    }
}
