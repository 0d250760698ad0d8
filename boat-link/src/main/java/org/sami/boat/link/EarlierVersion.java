package org.sami.boat.link;

import java.nio.ByteBuffer;

/** Messages to a peer of an earlier link version, in that version's frames, so that its users see what is wrong. */
public final class EarlierVersion {
    private static final int VERSION_1 = 1;

    private EarlierVersion() {}

    /**
     * A goodbye for a client.
     *
     * @param version the client's version
     * @return the whole frame, in this version's form unless the client's version had another one
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
