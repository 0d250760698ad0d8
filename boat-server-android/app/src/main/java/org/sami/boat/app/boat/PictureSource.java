package org.sami.boat.app.boat;

import java.io.IOException;

/** Takes pictures: the camera of a phone. For one thread at a time, but for {@link #trouble}, which is safe for use by several. */
public interface PictureSource {
    /** A phone without one. */
    PictureSource NONE = new PictureSource() {
        @Override
        public String trouble() {
            return "the phone has no camera";
        }

        @Override
        public byte[] take(int mostBytes) throws IOException {
            throw new IOException(trouble());
        }
    };

    /** Why no picture can be taken now, in words for people; empty text if one can. It may be another at any time, as permissions come and go. */
    String trouble();

    /**
     * Takes a picture of what is ahead now; waits some seconds for the camera.
     *
     * @param mostBytes a larger picture is refused before it is read
     * @return a JPEG file
     * @throws IOException with the reason in words, if there is none
     */
    byte[] take(int mostBytes) throws IOException;
}
