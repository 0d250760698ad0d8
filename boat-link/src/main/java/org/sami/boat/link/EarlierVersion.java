package org.sami.boat.link;

import java.nio.ByteBuffer;

/** What is said to a peer of an earlier version of the link in its own frames, so that it can tell its people what is wrong. */
public final class EarlierVersion {
    private static final int VERSION_1 = 1;

    private EarlierVersion() {}

    /**
     * A goodbye for a client.
     *
     * @param version what the client speaks
     * @return the whole frame; of this version, if that is none that had other frames
     */
    public static byte[] goodbye(int version, String boatId, String reason) {
        Goodbye goodbye = new Goodbye(boatId, reason);
        if (version != VERSION_1) {
            return new LinkCodec().encode(0, goodbye);
        }
        byte[] body = LinkCodec.body(goodbye);
        return ByteBuffer.allocate(LinkCodec.LENGTH_BYTES + 1 + body.length)
                .putInt(1 + body.length)
                .put((byte) VERSION_1)
                .put(body)
                .array();
    }
}
