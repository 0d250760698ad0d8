package org.sami.boat.link.security;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.SecureRandom;
import java.security.Signature;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;

/**
 * A certificate by which a key travels in TLS: X.509 version 3 in DER, ECDSA with SHA-256, signed with the key itself. It says nothing but the key; name and
 * dates are not looked at, so that no clock has to be right.
 */
final class SelfSignedCertificate {
    private static final int SEQUENCE = 0x30;
    private static final int SET = 0x31;
    private static final byte[] ECDSA_WITH_SHA256 = {0x06, 0x08, 0x2a, (byte) 0x86, 0x48, (byte) 0xce, 0x3d, 4, 3, 2};
    private static final byte[] COMMON_NAME = {0x06, 0x03, 0x55, 0x04, 0x03};
    private static final int UTC_TIME = 0x17; // of dates before 2050, with two digits of the year (RFC 5280, 4.1.2.5)
    private static final String FROM = "200101000000Z";
    private static final int GENERALIZED_TIME = 0x18; // of dates from 2050 on
    private static final String TO = "21200101000000Z";

    private SelfSignedCertificate() {}

    /** A certificate for a pair of keys on an elliptic curve. */
    static X509Certificate of(KeyPair keys) throws GeneralSecurityException {
        byte[] algorithm = tagged(SEQUENCE, ECDSA_WITH_SHA256);
        byte[] serial = tagged(
                0x02,
                new BigInteger(120, new SecureRandom()).add(BigInteger.ONE).toByteArray());
        byte[] name = tagged(
                SEQUENCE,
                tagged(SET, tagged(SEQUENCE, COMMON_NAME, tagged(0x0c, "SAMI link".getBytes(StandardCharsets.UTF_8)))));
        byte[] body = tagged(
                SEQUENCE,
                tagged(0xa0, tagged(0x02, new byte[] {2})), // version 3
                serial,
                algorithm,
                name,
                tagged(SEQUENCE, time(UTC_TIME, FROM), time(GENERALIZED_TIME, TO)),
                name,
                keys.getPublic().getEncoded());
        Signature signer = Signature.getInstance("SHA256withECDSA");
        signer.initSign(keys.getPrivate());
        signer.update(body);
        byte[] signature = signer.sign();
        byte[] certificate = tagged(SEQUENCE, body, algorithm, tagged(0x03, new byte[] {0}, signature));
        return (X509Certificate)
                CertificateFactory.getInstance("X.509").generateCertificate(new ByteArrayInputStream(certificate));
    }

    private static byte[] time(int tag, String text) {
        return tagged(tag, text.getBytes(StandardCharsets.US_ASCII));
    }

    /** One DER value: its tag, its length, its parts one after the other. */
    private static byte[] tagged(int tag, byte[]... parts) {
        ByteArrayOutputStream content = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            content.write(part, 0, part.length);
        }
        ByteArrayOutputStream value = new ByteArrayOutputStream();
        value.write(tag);
        int length = content.size();
        if (length < 0x80) {
            value.write(length);
        } else if (length < 0x100) {
            value.write(0x81);
            value.write(length);
        } else {
            value.write(0x82);
            value.write(length >> 8);
            value.write(length);
        }
        value.write(content.toByteArray(), 0, length);
        return value.toByteArray();
    }
}
