package org.sami.boat.app.phone;

import android.app.PendingIntent;
import android.content.Context;
import android.content.Intent;
import android.hardware.usb.UsbAccessory;
import android.hardware.usb.UsbManager;
import android.os.ParcelFileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;
import org.sami.boat.hull.stream.StreamConnection;
import org.sami.boat.hull.stream.StreamPort;

/**
 * The control board as a USB accessory of the phone. A board for which the phone has no permission yet is asked for once each time that it is attached: the phone
 * then shows its question. For one thread at a time.
 */
public final class UsbBoardPort implements StreamPort {
    /** The board's maker, by which it is known. */
    public static final String MANUFACTURER = "Platypus LLC";

    /** The board's model, by which it is known. */
    public static final String MODEL = "Platypus Server";

    private static final String ANSWERED = "org.sami.boat.app.USB_ANSWERED";

    private final Context context;
    private final UsbManager usb;
    private boolean asked; // since a board was plugged in

    /** The port of a phone. */
    public UsbBoardPort(Context context) {
        this.context = context;
        usb = (UsbManager) context.getSystemService(Context.USB_SERVICE);
    }

    @Override
    public String name() {
        return "USB";
    }

    @Override
    public StreamConnection open() throws IOException {
        Optional<UsbAccessory> board = attached();
        if (!board.isPresent()) {
            asked = false;
            throw new IOException("no board is plugged in");
        }
        if (!usb.hasPermission(board.get())) {
            ask(board.get());
            throw new IOException(
                    "the phone does not let the app use the board: answer its question with OK, or unplug the board and plug it in again");
        }
        ParcelFileDescriptor file = usb.openAccessory(board.get());
        if (file == null) {
            throw new IOException("the phone cannot open the board: unplug it and plug it in again");
        }
        return new Connection(file);
    }

    private Optional<UsbAccessory> attached() {
        UsbAccessory[] all = usb.getAccessoryList();
        if (all != null) {
            for (UsbAccessory accessory : all) {
                if (MANUFACTURER.equals(accessory.getManufacturer()) && MODEL.equals(accessory.getModel())) {
                    return Optional.of(accessory);
                }
            }
        }
        return Optional.empty();
    }

    private void ask(UsbAccessory board) {
        if (!asked) {
            asked = true;
            Intent answered = new Intent(ANSWERED).setPackage(context.getPackageName());
            usb.requestPermission(
                    board, PendingIntent.getBroadcast(context, 0, answered, 0)); // the port is tried again by itself
        }
    }

    /** An open accessory. */
    private static final class Connection implements StreamConnection {
        private final ParcelFileDescriptor file;
        private final InputStream in;
        private final OutputStream out;

        Connection(ParcelFileDescriptor file) {
            this.file = file;
            in = new FileInputStream(file.getFileDescriptor());
            out = new FileOutputStream(file.getFileDescriptor());
        }

        @Override
        public InputStream in() {
            return in;
        }

        @Override
        public OutputStream out() {
            return out;
        }

        @Override
        public void close() throws IOException {
            file.close();
        }
    }
}
