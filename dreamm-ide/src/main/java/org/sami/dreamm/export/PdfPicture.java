package org.sami.dreamm.export;

import java.awt.geom.Rectangle2D;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.util.Matrix;
import org.sami.picture.net.NetPicture;

/** A picture of a net as a PDF of one page, which is as large as the picture at 72 units to the inch. */
final class PdfPicture {
    private PdfPicture() {}

    static byte[] write(NetPicture picture) throws IOException {
        Rectangle2D area = picture.bounds();
        try (PDDocument document = new PDDocument()) {
            document.getDocumentInformation().setTitle(picture.drawing().title());
            document.getDocumentInformation().setCreator("SAMI DREAMM");
            PDPage page = new PDPage(new PDRectangle((float) area.getWidth(), (float) area.getHeight()));
            document.addPage(page);
            try (PDPageContentStream content = new PDPageContentStream(document, page)) {
                // y goes upwards in a PDF
                content.transform(new Matrix(1, 0, 0, -1, (float) -area.getX(), (float) area.getMaxY()));
                picture.paint(new PdfCanvas(content));
            } catch (UncheckedIOException fault) {
                throw fault.getCause();
            }
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            document.save(bytes);
            return bytes.toByteArray();
        }
    }
}
