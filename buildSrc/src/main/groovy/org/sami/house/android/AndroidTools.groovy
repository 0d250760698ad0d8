package org.sami.house.android

/** The tools of Debian that make an APK: there is no Android SDK on the machines of this project. */
class AndroidTools {
    /** How to get what is missing. */
    static final String INSTALL = 'apt-get install -y --no-install-recommends aapt apksigner zipalign android-framework-res'

    /** Resources of the framework, to which the app's own refer. */
    static final File FRAMEWORK = new File('/usr/share/android-framework-res/framework-res.apk')

    private AndroidTools() {}

    /** Names what of the tools is not installed; empty where an APK can be made. */
    static List<String> missing() {
        missing((System.getenv('PATH') ?: '').split(File.pathSeparator).collect { new File(it) }, FRAMEWORK)
    }

    static List<String> missing(List<File> path, File framework) {
        def programs = ['aapt', 'apksigner', 'zipalign'].findAll { name -> !path.any { new File(it, name).canExecute() } }
        framework.file ? programs : programs + 'android-framework-res'
    }

    /** One line that says what is not made for want of these tools. */
    static String line(List<String> missing) {
        "no APK is built and the app's tests are left out: ${missing.join(', ')} missing; get them by: $INSTALL"
    }
}
