package org.sami.crw.cli.key;

import com.google.zxing.WriterException;
import com.google.zxing.qrcode.decoder.ErrorCorrectionLevel;
import com.google.zxing.qrcode.encoder.ByteMatrix;
import com.google.zxing.qrcode.encoder.Encoder;

/** A text as a QR code: a square of dark and light modules. Immutable. */
public final class QrCode {
    /** Light modules around it, without which readers do not find it. */
    public static final int QUIET = 4;

    private static final int QUIET_IN_TERMINAL = 2; // readers find it there too, and a terminal has 24 lines
    private static final String BLACK_ON_WHITE = "\u001b[38;5;16;48;5;231m";
    private static final String AS_BEFORE = "\u001b[0m";

    private final ByteMatrix modules;

    private QrCode(ByteMatrix modules) {
        this.modules = modules;
    }

    /**
     * The code of a text.
     *
     * @throws IllegalArgumentException if the text is too long for one
     */
    public static QrCode of(String text) {
        try {
            return new QrCode(Encoder.encode(text, ErrorCorrectionLevel.L).getMatrix());
        } catch (WriterException e) {
            throw new IllegalArgumentException("no QR code holds this: " + e.getMessage(), e);
        }
    }

    /** Modules along each side, without the quiet ones around it. */
    public int size() {
        return modules.getWidth();
    }

    /** Whether a module is dark; those outside are light. */
    public boolean isDark(int column, int row) {
        return column >= 0 && row >= 0 && column < size() && row < size() && modules.get(column, row) == 1;
    }

    /**
     * Lines of half blocks, two rows of modules each.
     *
     * @param colored whether the terminal writes black on white; else dark modules have the colour of its letters
     */
    public String halfBlocks(boolean colored) {
        StringBuilder text = new StringBuilder();
        int end = size() + QUIET_IN_TERMINAL;
        for (int row = -QUIET_IN_TERMINAL; row < end; row += 2) {
            text.append(colored ? BLACK_ON_WHITE : "");
            for (int column = -QUIET_IN_TERMINAL; column < end; column++) {
                text.append(half(isDark(column, row), isDark(column, row + 1)));
            }
            text.append(colored ? AS_BEFORE : "").append('\n');
        }
        return text.toString();
    }

    private static char half(boolean upper, boolean lower) {
        if (upper) {
            return lower ? '█' : '▀';
        }
        return lower ? '▄' : ' ';
    }
}
