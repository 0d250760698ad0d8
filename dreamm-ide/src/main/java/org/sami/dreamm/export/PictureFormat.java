package org.sami.dreamm.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.sami.picture.net.NetPicture;

/** The formats in which a plan can be exported as a picture. */
public enum PictureFormat {
    /** Pixels, two for a unit of the drawing. */
    PNG("png", "PNG") {
        @Override
        public byte[] write(NetPicture picture) throws IOException {
            return picture.png();
        }
    },
    /** Lines and texts for browsers and drawing programs. */
    SVG("svg", "SVG") {
        @Override
        public byte[] write(NetPicture picture) {
            return picture.svg().getBytes(StandardCharsets.UTF_8);
        }
    },
    /** One page as large as the net. */
    PDF("pdf", "PDF") {
        @Override
        public byte[] write(NetPicture picture) throws IOException {
            return PdfPicture.write(picture);
        }
    };

    private final String suffix;
    private final String label;

    PictureFormat(String suffix, String label) {
        this.suffix = suffix;
        this.label = label;
    }

    /** How names of its files end, without the dot. */
    public String suffix() {
        return suffix;
    }

    /** What people call it. */
    public String label() {
        return label;
    }

    /**
     * Writes a picture.
     *
     * @throws IOException if it cannot be written
     */
    public abstract byte[] write(NetPicture picture) throws IOException;
}
