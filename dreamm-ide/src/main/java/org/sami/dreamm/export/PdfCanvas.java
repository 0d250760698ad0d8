package org.sami.dreamm.export;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.text.Normalizer;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.font.PDFont;
import org.apache.pdfbox.pdmodel.font.PDType1Font;
import org.apache.pdfbox.pdmodel.font.Standard14Fonts;
import org.apache.pdfbox.pdmodel.graphics.state.PDExtendedGraphicsState;
import org.apache.pdfbox.pdmodel.graphics.state.RenderingMode;
import org.apache.pdfbox.util.Matrix;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;

/**
 * Paints on the page of a PDF. Texts are their letters' outlines, so that they look as measured on any machine; below them the same text lies
 * invisibly, so that it can be searched and copied.
 */
final class PdfCanvas implements Canvas {
    private static final PDFont SEARCHED = new PDType1Font(Standard14Fonts.FontName.HELVETICA);

    private final PDPageContentStream page;

    /** Paints in the page's units, y downwards. */
    PdfCanvas(PDPageContentStream page) {
        this.page = page;
    }

    /** Something that is written to the page. */
    private interface Writing {
        void run() throws IOException;
    }

    private static void write(Writing writing) {
        try {
            writing.run();
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    @Override
    public void fill(Shape shape, Color color) {
        write(() -> {
            page.setNonStrokingColor(color);
            opaque(color);
            append(shape);
            page.fill();
        });
    }

    @Override
    public void draw(Shape shape, Color color, BasicStroke stroke) {
        write(() -> {
            float[] dash = stroke.getDashArray();
            page.setStrokingColor(color);
            opaque(color);
            page.setLineWidth(stroke.getLineWidth());
            page.setLineDashPattern(dash == null ? new float[0] : dash, 0);
            append(shape);
            page.stroke();
        });
    }

    private void opaque(Color color) throws IOException {
        PDExtendedGraphicsState state = new PDExtendedGraphicsState();
        state.setNonStrokingAlphaConstant(color.getAlpha() / 255f);
        state.setStrokingAlphaConstant(color.getAlpha() / 255f);
        page.setGraphicsStateParameters(state);
    }

    @Override
    public void text(String text, Font font, Color color, double x, double baseline) {
        write(() -> {
            page.beginText();
            page.setRenderingMode(RenderingMode.NEITHER);
            page.setFont(SEARCHED, font.getSize2D());
            page.setTextMatrix(new Matrix(1, 0, 0, -1, (float) x, (float) baseline)); // letters stand upright
            page.showText(plain(text));
            page.endText();
        });
        Shape letters = font.createGlyphVector(NetFonts.CONTEXT, text).getOutline((float) x, (float) baseline);
        fill(letters, color);
    }

    /** The text in the letters that every reader of PDF has: those of Windows-1252. */
    private static String plain(String text) {
        String spelt =
                text.replace("≥", ">=").replace("→", "->").replace("←", "<-").replace("−", "-");
        StringBuilder plain = new StringBuilder();
        for (char letter : Normalizer.normalize(spelt, Normalizer.Form.NFC).toCharArray()) {
            boolean known = (letter >= 0x20 && letter < 0x7F) || (letter >= 0xA0 && letter <= 0xFF);
            plain.append(known ? letter : '?');
        }
        return plain.toString();
    }

    private void append(Shape shape) throws IOException {
        double[] p = new double[6];
        double x = 0;
        double y = 0;
        for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
            switch (i.currentSegment(p)) {
                case PathIterator.SEG_MOVETO -> {
                    page.moveTo((float) p[0], (float) p[1]);
                    x = p[0];
                    y = p[1];
                }
                case PathIterator.SEG_LINETO -> {
                    page.lineTo((float) p[0], (float) p[1]);
                    x = p[0];
                    y = p[1];
                }
                case PathIterator.SEG_QUADTO -> { // as a cubic curve, which is what a PDF has
                    page.curveTo(
                            (float) (x + 2 * (p[0] - x) / 3),
                            (float) (y + 2 * (p[1] - y) / 3),
                            (float) (p[2] + 2 * (p[0] - p[2]) / 3),
                            (float) (p[3] + 2 * (p[1] - p[3]) / 3),
                            (float) p[2],
                            (float) p[3]);
                    x = p[2];
                    y = p[3];
                }
                case PathIterator.SEG_CUBICTO -> {
                    page.curveTo((float) p[0], (float) p[1], (float) p[2], (float) p[3], (float) p[4], (float) p[5]);
                    x = p[4];
                    y = p[5];
                }
                default -> page.closePath();
            }
        }
    }
}
