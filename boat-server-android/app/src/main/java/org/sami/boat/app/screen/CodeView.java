package org.sami.boat.app.screen;

import android.content.Context;
import android.graphics.Canvas;
import android.graphics.Color;
import android.graphics.Paint;
import android.util.AttributeSet;
import android.view.View;
import com.google.zxing.BarcodeFormat;
import com.google.zxing.EncodeHintType;
import com.google.zxing.WriterException;
import com.google.zxing.common.BitMatrix;
import com.google.zxing.qrcode.QRCodeWriter;
import com.google.zxing.qrcode.decoder.ErrorCorrectionLevel;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Shows a text as a QR code: black on white in the dark too, with the margin of four modules that readers need, as wide as its place. For the main thread. */
public final class CodeView extends View {
    private static final int MARGIN_MODULES = 4;

    private final Paint dark = new Paint();
    private String text = "";
    private Optional<BitMatrix> modules = Optional.empty();

    /** A view that is described by a layout. */
    public CodeView(Context context, @Nullable AttributeSet attributes) {
        super(context, attributes);
        dark.setColor(Color.BLACK);
    }

    /** Shows another text of at most some hundred characters. */
    void show(String newText) {
        if (newText.equals(text)) {
            return;
        }
        Map<EncodeHintType, Object> hints = new EnumMap<>(EncodeHintType.class);
        hints.put(EncodeHintType.ERROR_CORRECTION, ErrorCorrectionLevel.L);
        hints.put(EncodeHintType.MARGIN, MARGIN_MODULES);
        try {
            modules = Optional.of(new QRCodeWriter().encode(newText, BarcodeFormat.QR_CODE, 0, 0, hints));
        } catch (WriterException e) {
            throw new IllegalArgumentException("no QR code holds " + newText.length() + " characters", e);
        }
        text = newText;
        invalidate();
    }

    /** A square, and not higher than a phone that lies on its side. */
    @Override
    protected void onMeasure(int widthSpec, int heightSpec) {
        int wide = MeasureSpec.getSize(widthSpec);
        int most = getResources().getDisplayMetrics().heightPixels;
        setMeasuredDimension(wide, Math.min(wide, most));
    }

    @Override
    protected void onDraw(Canvas canvas) {
        modules.ifPresent(code -> draw(canvas, code));
    }

    /** Modules of whole pixels, so that none is wider than another. */
    private void draw(Canvas canvas, BitMatrix code) {
        int pixels = Math.max(1, Math.min(getWidth(), getHeight()) / code.getWidth());
        int left = (getWidth() - pixels * code.getWidth()) / 2;
        int top = (getHeight() - pixels * code.getHeight()) / 2;
        canvas.drawColor(Color.WHITE);
        for (int y = 0; y < code.getHeight(); y++) {
            for (int x = 0; x < code.getWidth(); x++) {
                if (code.get(x, y)) {
                    int atX = left + x * pixels;
                    int atY = top + y * pixels;
                    canvas.drawRect(atX, atY, atX + pixels, atY + pixels, dark);
                }
            }
        }
    }
}
