package org.sami.crw.proxy.phone;

import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * The page that a phone's browser shows: fetch the app, then open it with the pairing code. The code comes from behind the {@code #} of the page's own address; a
 * link of Android's form {@code intent:} hands it to the app.
 */
final class AppPage {
    /** Nothing is loaded and nothing is sent; the page's own script and style count. */
    static final String POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'";

    private static final String PAGE = """
        <!DOCTYPE html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <meta name="color-scheme" content="light dark">
        <title>SAMI boat</title>
        <style>
        body { font: 20px sans-serif; margin: 1em; max-width: 32em }
        a { display: block; padding: 1em; margin: 1em 0; background: #0b5; color: #000; text-align: center; font-weight: bold; text-decoration: none; border-radius: 8px }
        small { font-size: 14px; overflow-wrap: anywhere }
        </style>
        </head>
        <body>
        <h1>SAMI boat</h1>
        <p id="missing" hidden><b>The app is not on this phone yet: step 1. Then scan the code again.</b></p>
        <h2>1. Install the app</h2>
        {APP}
        <h2>2. Pair this phone</h2>
        <p id="none">This address has no pairing code: scan the code of the base again, with the phone that is in the boat.</p>
        <p id="some" hidden><a id="pair">Open the app and pair</a>
        Compare the six digits that phone and base show then.</p>
        <script>
        var code = location.hash.slice(1);
        if (code.indexOf('SAMI') === 0) {
          document.getElementById('pair').href = 'intent://pair/' + encodeURIComponent(code)
            + '#Intent;scheme=sami-boat;package=org.sami.boat.app;S.browser_fallback_url={BACK};end';
          document.getElementById('some').hidden = false;
          document.getElementById('none').hidden = true;
        }
        if (location.search === '?missing') {
          document.getElementById('missing').hidden = false;
        }
        </script>
        </body>
        </html>
        """;

    private AppPage() {}

    /**
     * The page.
     *
     * @param url its own address, to which the browser comes back where the app is not installed
     */
    static String of(Optional<ApkFile> apk, String url) {
        String app = apk.map(file -> "<p><a href=\"" + AppServer.APK_NAME + "\">Download (" + file.size() + ")</a>"
                        + "Open the download, and allow the installation from this browser. Come back here then.<br>"
                        + "<small>SHA-256 " + file.sha256() + "</small></p>")
                .orElse("<p>The base has no copy of the app to give. If it is on this phone already, go on with step"
                        + " 2.</p>");
        String back = URLEncoder.encode(url + "?missing", StandardCharsets.UTF_8);
        return PAGE.replace("{APP}", app).replace("{BACK}", back);
    }
}
