package org.sami.boat.app.phone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import android.app.Application;
import android.content.Context;
import android.hardware.usb.UsbAccessory;
import android.hardware.usb.UsbManager;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowUsbManager;
import org.sami.boat.hull.stream.StreamConnection;

/** The board as a USB accessory: attached, denied, allowed later, detached. */
@RunWith(RobolectricTestRunner.class)
public class UsbBoardPortTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ShadowUsbManager usb = Shadow.extract((UsbManager) phone.getSystemService(Context.USB_SERVICE));
    private final UsbBoardPort port = new UsbBoardPort(phone);

    private static UsbAccessory accessory(String manufacturer, String model) {
        return new UsbAccessory(manufacturer, model, "board", "3.0", "", "1");
    }

    private static UsbAccessory board() {
        return accessory("Platypus LLC", "Platypus Server");
    }

    @Test
    public void withoutABoardItSaysSo() {
        assertThatThrownBy(port::open).isInstanceOf(IOException.class).hasMessage("no board is plugged in");
    }

    @Test
    public void anotherAccessoryIsNotTheBoard() {
        UsbAccessory other = accessory("Somebody", "Loudspeaker");
        usb.setAttachedUsbAccessory(other);
        usb.grantPermission(other);

        assertThatThrownBy(port::open).hasMessage("no board is plugged in");
    }

    @Test
    public void deniedBoardIsOpenedOnceItIsAllowed() throws Exception {
        UsbAccessory board = board();
        usb.setAttachedUsbAccessory(board);
        assertThatThrownBy(port::open).isInstanceOf(IOException.class).hasMessageContaining("answer its question");
        assertThatThrownBy(port::open).hasMessageContaining("answer its question");

        usb.grantPermission(board);

        try (StreamConnection open = port.open()) {
            open.out().write("{}\r\n".getBytes(StandardCharsets.US_ASCII));
        }
    }

    @Test
    public void boardThatWasPulledAndPutBackIsOpenedAgain() throws Exception {
        UsbAccessory board = board();
        usb.setAttachedUsbAccessory(board);
        usb.grantPermission(board);
        port.open().close();

        usb.setAttachedUsbAccessory(null);
        assertThatThrownBy(port::open).hasMessage("no board is plugged in");

        usb.setAttachedUsbAccessory(board);
        assertThat(port.open()).isNotNull();
    }
}
