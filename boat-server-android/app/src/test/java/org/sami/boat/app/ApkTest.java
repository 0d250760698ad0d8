package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;

/** The APK as it was built: what it asks for, what is in it, that it is signed. */
class ApkTest {
    private static final Path APK = Path.of(System.getProperty("apk"));

    @Test
    void asksForTheseRightsAndNoOthers() throws Exception {
        List<String> rights = run("aapt", "dump", "permissions", APK.toString())
                .lines()
                .filter(line -> line.startsWith("uses-permission"))
                .map(line -> line.replaceAll(".*'android\\.permission\\.(\\w+)'.*", "$1"))
                .collect(Collectors.toList());

        assertThat(rights)
                .containsExactlyInAnyOrder(
                        "INTERNET", // the boat server listens
                        "FOREGROUND_SERVICE",
                        "WAKE_LOCK", // processor and Wi-Fi with the screen off
                        "REQUEST_IGNORE_BATTERY_OPTIMIZATIONS", // network in doze
                        "RECEIVE_BOOT_COMPLETED",
                        "ACCESS_FINE_LOCATION",
                        "CAMERA",
                        "ACCESS_BACKGROUND_LOCATION"); // the service was begun at boot
    }

    @Test
    void runsFromApi26OnAndNamesItsVersion() throws Exception {
        String badging = run("aapt", "dump", "badging", APK.toString());

        assertThat(badging)
                .contains("package: name='org.sami.boat.app' versionCode='")
                .contains("sdkVersion:'26'")
                .contains("targetSdkVersion:'29'")
                .doesNotContain("application-debuggable");
    }

    @Test
    void isSignedAndUnder4Megabytes() throws Exception {
        assertThat(run("apksigner", "verify", "--verbose", "--min-sdk-version", "26", APK.toString()))
                .contains("Verifies")
                .contains("Verified using v2 scheme (APK Signature Scheme v2): true");
        assertThat(Files.size(APK)).isLessThan(4_000_000);
    }

    @Test
    void containsClassesResourcesAndTheLicencesOfItsLibraries() throws Exception {
        try (ZipFile zip = new ZipFile(APK.toFile())) {
            assertThat(zip.stream().map(ZipEntry::getName))
                    .contains("classes.dex", "resources.arsc", "AndroidManifest.xml", "assets/LICENSE");
            ZipEntry notice = zip.getEntry("assets/THIRD-PARTY.txt");
            String text = new String(zip.getInputStream(notice).readAllBytes(), StandardCharsets.UTF_8);
            assertThat(text).contains("jackson-databind").doesNotContain("robolectric");
        }
    }

    /** Android throws there whatever is asked: keys and logs could not be kept. */
    @Test
    void asksForNoFileStoreWhichAndroidRefuses() throws Exception {
        try (ZipFile zip = new ZipFile(APK.toFile())) {
            byte[] dex = zip.getInputStream(zip.getEntry("classes.dex")).readAllBytes();
            assertThat(new String(dex, StandardCharsets.ISO_8859_1))
                    .contains("supportedFileAttributeViews")
                    .doesNotContain("getFileStore");
        }
    }

    private static String run(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
        return said;
    }
}
