package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigInteger;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.time.Instant;
import java.util.Date;
import java.util.HashSet;
import java.util.Set;
import org.bouncycastle.asn1.ASN1BitString;
import org.bouncycastle.asn1.ASN1Encoding;
import org.bouncycastle.asn1.ASN1GeneralizedTime;
import org.bouncycastle.asn1.ASN1ObjectIdentifier;
import org.bouncycastle.asn1.ASN1Sequence;
import org.bouncycastle.asn1.ASN1UTCTime;
import org.bouncycastle.asn1.ASN1UTF8String;
import org.bouncycastle.asn1.sec.SECObjectIdentifiers;
import org.bouncycastle.asn1.x500.RDN;
import org.bouncycastle.asn1.x500.style.BCStyle;
import org.bouncycastle.asn1.x509.AlgorithmIdentifier;
import org.bouncycastle.asn1.x509.Certificate;
import org.bouncycastle.asn1.x509.TBSCertificate;
import org.bouncycastle.asn1.x9.X9ObjectIdentifiers;
import org.bouncycastle.cert.X509CertificateHolder;
import org.bouncycastle.jce.provider.BouncyCastleProvider;
import org.bouncycastle.operator.jcajce.JcaContentVerifierProviderBuilder;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** BouncyCastle, which had no part in writing it, reads each field of a certificate as RFC 5280 asks for, and verifies its signature. */
class SelfSignedCertificateTest {
    private KeyPair keys;
    private X509CertificateHolder read;

    @BeforeEach
    void write() throws Exception {
        keys = newKeys();
        read = new X509CertificateHolder(SelfSignedCertificate.of(keys).getEncoded());
    }

    private static KeyPair newKeys() throws Exception {
        KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
        generator.initialize(new ECGenParameterSpec("secp256r1"));
        return generator.generateKeyPair();
    }

    @Test
    void itsBytesAreTheOnesThatAnotherWriterOfDerMakesOfItsFields() throws Exception {
        byte[] written = SelfSignedCertificate.of(keys).getEncoded();

        Certificate structure = Certificate.getInstance(ASN1Sequence.getInstance(written));

        assertThat(structure.getEncoded(ASN1Encoding.DER)).isEqualTo(written);
    }

    @Test
    void itIsOfVersionThreeWithoutExtensionsAndUniqueIds() {
        TBSCertificate body = read.toASN1Structure().getTBSCertificate();

        assertThat(body.getVersionNumber()).isEqualTo(3);
        assertThat(body.getExtensions()).isNull();
        assertThat(body.getIssuerUniqueId()).isNull();
        assertThat(body.getSubjectUniqueId()).isNull();
    }

    @Test
    void itsNumberIsPositiveShortAndItsOwn() throws Exception {
        Set<BigInteger> numbers = new HashSet<>();
        for (int i = 0; i < 100; i++) {
            BigInteger number =
                    new X509CertificateHolder(SelfSignedCertificate.of(keys).getEncoded()).getSerialNumber();
            assertThat(number.signum()).isPositive();
            assertThat(number.toByteArray()).hasSizeLessThanOrEqualTo(20);
            numbers.add(number);
        }

        assertThat(numbers).hasSize(100);
    }

    @Test
    void bothItsAlgorithmsAreEcdsaWithSha256WithoutParameters() {
        AlgorithmIdentifier outside = read.getSignatureAlgorithm();
        AlgorithmIdentifier inside = read.toASN1Structure().getTBSCertificate().getSignature();

        assertThat(outside).isEqualTo(inside);
        assertThat(outside.getAlgorithm()).isEqualTo(X9ObjectIdentifiers.ecdsa_with_SHA256);
        assertThat(outside.getParameters()).as("none (RFC 5758, 3.2)").isNull();
    }

    @Test
    void issuerAndSubjectAreOneCommonNameInUtf8() {
        assertThat(read.getIssuer()).isEqualTo(read.getSubject());
        RDN[] parts = read.getSubject().getRDNs();
        assertThat(parts).hasSize(1);
        assertThat(parts[0].isMultiValued()).isFalse();
        assertThat(parts[0].getFirst().getType()).isEqualTo(BCStyle.CN);
        assertThat(parts[0].getFirst().getValue()).isInstanceOf(ASN1UTF8String.class);
        assertThat(((ASN1UTF8String) parts[0].getFirst().getValue()).getString())
                .isEqualTo("SAMI link");
    }

    @Test
    void datesBeforeTheYear2050HaveTwoDigitsOfTheYearAndOthersFour() {
        TBSCertificate body = read.toASN1Structure().getTBSCertificate();

        assertThat(body.getStartDate().toASN1Primitive()).isInstanceOf(ASN1UTCTime.class);
        assertThat(body.getEndDate().toASN1Primitive()).isInstanceOf(ASN1GeneralizedTime.class);
        assertThat(read.getNotBefore()).isEqualTo(Date.from(Instant.parse("2020-01-01T00:00:00Z")));
        assertThat(read.getNotAfter()).isEqualTo(Date.from(Instant.parse("2120-01-01T00:00:00Z")));
    }

    @Test
    void itCarriesTheKeyOnTheNamedCurve() throws Exception {
        AlgorithmIdentifier kind = read.getSubjectPublicKeyInfo().getAlgorithm();

        assertThat(kind.getAlgorithm()).isEqualTo(X9ObjectIdentifiers.id_ecPublicKey);
        assertThat(ASN1ObjectIdentifier.getInstance(kind.getParameters())).isEqualTo(SECObjectIdentifiers.secp256r1);
        assertThat(read.getSubjectPublicKeyInfo().getEncoded())
                .isEqualTo(keys.getPublic().getEncoded());
        assertThat(Fingerprint.of(BouncyCastleProvider.getPublicKey(read.getSubjectPublicKeyInfo())))
                .as("the fingerprint does not depend on who reads the key")
                .isEqualTo(Fingerprint.of(keys.getPublic()));
    }

    @Test
    void itsSignatureIsOfItsKeyAndOfNoOther() throws Exception {
        JcaContentVerifierProviderBuilder verifier =
                new JcaContentVerifierProviderBuilder().setProvider(new BouncyCastleProvider());

        assertThat(read.isSignatureValid(verifier.build(keys.getPublic()))).isTrue();
        assertThat(read.isSignatureValid(verifier.build(newKeys().getPublic()))).isFalse();
        ASN1BitString signature = read.toASN1Structure().getSignature();
        assertThat(signature.getPadBits()).isZero();
    }

    @Test
    void oneFlippedBitInItsBodyIsSeen() throws Exception {
        byte[] bent = read.getEncoded();
        bent[20] ^= 1; // of its number
        X509CertificateHolder other = new X509CertificateHolder(bent);

        assertThat(other.isSignatureValid(new JcaContentVerifierProviderBuilder()
                        .setProvider(new BouncyCastleProvider())
                        .build(keys.getPublic())))
                .isFalse();
    }

    @Test
    void thePlatformsOwnReaderAgrees() throws Exception {
        X509Certificate certificate = SelfSignedCertificate.of(keys);

        certificate.verify(keys.getPublic());
        certificate.checkValidity(Date.from(Instant.parse("2026-11-26T00:00:00Z")));
        assertThat(certificate.getPublicKey()).isEqualTo(keys.getPublic());
    }
}
